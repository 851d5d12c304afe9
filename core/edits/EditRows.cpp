// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditRows.h"

#include "core/edits/kinds/AnyEdit.h"

#include <type_traits>

namespace core {

namespace {

template <class E>
concept saysItsTitle = requires
{
    static_cast<RowTitle (*)(const E&, const RowFacts&)>(&rowTitle);
};

template <class E>
concept saysItsReach = requires
{
    static_cast<EditReach (*)(const E&, const ReachFacts&)>(&reach);
};

} // namespace

RowTitle titleOf(const Edit& edit, const RowFacts& row)
{
    return visitEdit(
        [&row](const auto& known) {
            static_assert(saysItsTitle<std::decay_t<decltype(known)>>,
                "an edit X needs RowTitle rowTitle(const X&, const RowFacts&)");
            return rowTitle(known, row);
        },
        edit);
}

EditReach reachOf(const Edit& edit, const ReachFacts& row)
{
    return visitEdit(
        [&row](const auto& known) {
            static_assert(saysItsReach<std::decay_t<decltype(known)>>,
                "an edit X needs EditReach reach(const X&, const ReachFacts&)");
            return reach(known, row);
        },
        edit);
}

} // namespace core
