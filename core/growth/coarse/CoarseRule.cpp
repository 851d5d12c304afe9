// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseRule.h"

#include <algorithm>
#include <cstddef>

namespace core {

namespace {

constexpr int codeCount = 1 << 16;

} // namespace

std::vector<std::uint8_t> codesWithin(
    const CoarseRule& rule, const std::optional<std::vector<CodeInterval>>& among)
{
    std::vector<std::uint8_t> codes(codeCount, 0);
    const auto admit = [&](int low, int high) {
        const int last = std::min({high, rule.highCode, codeCount - 1});
        for (int code = std::max({low, rule.lowCode, 0}); code <= last; ++code)
            codes[std::size_t(code)] = 1;
    };
    if (!among)
        admit(0, codeCount - 1);
    for (const CodeInterval& interval : among.value_or(std::vector<CodeInterval>()))
        admit(interval.low, interval.high);
    return codes;
}

} // namespace core
