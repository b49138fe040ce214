#include <stylet/contract/plugin.h>

#include <stylet/contract/contract.h>

#include "checks.h"

#include <dlfcn.h>

#include <deque>
#include <functional>

namespace stylet::contract {
namespace {

/// A test whose body is a function.
class FunctionTest : public testing::Test {
public:
    explicit FunctionTest(std::function<void()> body) : body_(std::move(body)) {}
    void TestBody() override { body_(); }

private:
    std::function<void()> body_;
};

void add_test(const std::string& suite, const std::string& name, const std::function<void()>& body) {
    testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [body]() -> testing::Test* { return std::make_unique<FunctionTest>(body).release(); });
}

const char* suite_of(Role role) {
    switch (role) {
        case Role::tissue:
            return "TissueContract";
        case Role::needle:
            return "NeedleContract";
        case Role::buckling:
            return "BucklingContract";
        case Role::effect:
            return "EffectContract";
        case Role::device:
            return "DeviceContract";
    }
    return "Contract";
}

std::deque<Case>& kept_cases() {    // what an object is made from must outlive it
    static std::deque<Case> cases;
    return cases;
}

}    // namespace

const Descriptor& load(const std::string& file) {
    void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw Error(std::string("cannot load the plugin's library: ") + dlerror());
    const void* const descriptor = dlsym(library, "stylet_plugin");
    if (descriptor == nullptr)
        throw Error("the library " + file + " exports no stylet_plugin: wanted a STYLET_PLUGIN line in it");
    return *static_cast<const Descriptor*>(descriptor);
}

std::vector<Check> checks_of(Role role) {
    std::vector<Check> checks = descriptor_checks();
    std::vector<Check> more;
    switch (role) {
        case Role::tissue:
            more = tissue_checks();
            break;
        case Role::needle:
            more = needle_checks();
            break;
        case Role::buckling:
            more = buckling_checks();
            break;
        case Role::effect:
            more = effect_checks();
            break;
        case Role::device:
            more = device_checks();
            break;
    }
    checks.insert(checks.end(), more.begin(), more.end());
    return checks;
}

bool add(const char* file, std::vector<Case> cases) {
    const Descriptor* plugin = nullptr;
    try {
        plugin = &load(file);
    } catch (const Error& error) {
        add_test("Contract", "PluginLoads", [message = std::string(error.what())] { FAIL() << message; });
        return false;
    }
    for (Case& with : cases) {
        const Case& kept = kept_cases().emplace_back(std::move(with));
        for (const Check& check : checks_of(plugin->role)) {
            add_test(suite_of(plugin->role), std::string(check.name) + "/" + kept.name, [=, &kept] { check.run(*plugin, kept); });
        }
    }
    return true;
}

}    // namespace stylet::contract
