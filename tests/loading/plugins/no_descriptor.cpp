extern "C" __attribute__((visibility("default"))) int another_symbol() {
    return 1;
}
