// SPDX-License-Identifier: Apache-2.0
#include "core/base/FixedPoint.h"

#include <cmath>

namespace core {

std::int64_t fixedPoint::squareRoot(std::int64_t value)
{
    // A double has 53 bits; what it is off by is mended in whole numbers.
    auto root = std::int64_t(std::sqrt(double(value)));
    while (root * root > value)
        --root;
    while ((root + 1) * (root + 1) <= value)
        ++root;
    return root;
}

} // namespace core
