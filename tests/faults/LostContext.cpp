// SPDX-License-Identifier: Apache-2.0

// Preloaded into the program: its graphics driver loses the context where the program looks for GL
// errors (support/faults/LosingGl.h). By environment variables:
//   BURIN_LOSE_NTH     at which look, counted from 1; 0: at none, they are counted only
//   BURIN_LOSE_EVERY   after so many more another context, and so on; 0: never again
//   BURIN_LOSE_STATUS  1: told by the reset status alone
//   BURIN_LOSE_REPORT  a file that says how many looks there were and how many contexts were lost,
//                      when the program is left orderly

#include "tests/support/faults/LosingGl.h"

#include <cstdio>
#include <cstdlib>

namespace {

int numberFrom(const char* name)
{
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : 0;
}

/// As long as the program.
struct Loss {
    test::LosingGl losing{numberFrom("BURIN_LOSE_NTH"), numberFrom("BURIN_LOSE_EVERY"),
        numberFrom("BURIN_LOSE_STATUS") != 0 ? test::LosingGl::Tells::ByStatus
                                             : test::LosingGl::Tells::ByError};

    ~Loss()
    {
        const char* path = std::getenv("BURIN_LOSE_REPORT");
        // Programs that it starts (decoders) draw nothing.
        if (!path || losing.looks() == 0)
            return;
        if (std::FILE* file = std::fopen(path, "w")) {
            std::fprintf(file, "%d %d\n", losing.looks(), losing.lost());
            std::fclose(file);
        }
    }
};

const Loss loss;

} // namespace
