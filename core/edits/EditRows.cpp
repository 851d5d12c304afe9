// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditRows.h"

#include "core/edits/kinds/AnyEdit.h"

#include <type_traits>

namespace core {

namespace {

template <class E>
concept saysItsName = requires
{
    static_cast<QString (*)(const E&, const RowFacts&)>(&rowName);
};

template <class E>
concept saysItsReach = requires
{
    static_cast<EditReach (*)(const E&, const ReachFacts&)>(&reach);
};

} // namespace

QString nameOf(const Edit& edit, const RowFacts& row)
{
    return visitEdit(
        [&row](const auto& known) {
            static_assert(saysItsName<std::decay_t<decltype(known)>>,
                "an edit X needs QString rowName(const X&, const RowFacts&)");
            return rowName(known, row);
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
