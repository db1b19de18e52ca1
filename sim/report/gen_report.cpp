// gen_report.cpp - prints REPORT.md from the table of report.json's keys
#include <iostream>

#include "sim/report/report_keys.h"

int main() {
    std::cout
        << "# report.json\n\n"
           "Printed from `report_keys.h` by `make regmap`. What depends on the machine is under "
           "`wall` alone:\nwithout it, two runs of the same inputs are equal byte for byte, unless "
           "the program had a network.\n`[]` stands for the entries of a list, `*` for names.\n\n"
           "| Key | What |\n|---|---|\n";
    for (const sim::ReportKey& key : sim::REPORT_KEYS)
        std::cout << "| `" << key.path << "` | " << key.what << " |\n";
}
