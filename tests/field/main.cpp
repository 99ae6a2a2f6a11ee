/// make field: runs every case of every family; prints the failures and one line per family.
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <string>

#include "field/field_case.h"
#include "ripstop/base/parallel.h"

int main(int argc, char** argv) {
    using namespace ripstop;
    const std::string wanted = argc > 1 ? argv[1] : "";
    std::vector<field::Case> cases;
    for (field::Case& each : field::field_cases())
        if (each.text().find(wanted) != std::string::npos) cases.push_back(std::move(each));
    struct Outcome {
        std::vector<std::string> wrong;
        double seconds = 0;
    };
    std::vector<Outcome> outcomes(cases.size());
    parallel_for(static_cast<int>(cases.size()), 0, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        const auto start = std::chrono::steady_clock::now();
        outcomes[k].wrong = field::failures_of(cases[k]);
        outcomes[k].seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
    struct Family {
        int passed = 0, failed = 0;
        double seconds = 0;
    };
    std::map<std::string, Family> families;
    int passed = 0, failed = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Family& family = families[cases[i].family];
        family.seconds += outcomes[i].seconds;
        const bool is_right = outcomes[i].wrong.empty();
        ++(is_right ? family.passed : family.failed);
        ++(is_right ? passed : failed);
        for (const std::string& sentence : outcomes[i].wrong) fmt::print("{}: {}\n", cases[i].text(), sentence);
    }
    for (const auto& [name, family] : families)
        fmt::print("{:<8} {:5d} passed {:5d} failed {:8.1f} s\n", name, family.passed, family.failed, family.seconds);
    fmt::print("{} passed, {} failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}
