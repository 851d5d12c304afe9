// SPDX-License-Identifier: Apache-2.0
#include "core/volume/Volume.h"

#include <algorithm>

namespace core {

bool Volume::needsCaution() const
{
    return std::any_of(problems.begin(), problems.end(),
        [](const VolumeProblem& problem) { return problem.caution; });
}

} // namespace core
