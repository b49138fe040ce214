#include <stylet/contract/contract.h>
