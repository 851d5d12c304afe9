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
concept saysItsDependencies = requires
{
    static_cast<EditDependencies (*)(const E&, const DependencyFacts&)>(&dependencies);
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

EditDependencies dependenciesOf(const Edit& edit, const DependencyFacts& row)
{
    return visitEdit(
        [&row](const auto& known) {
            static_assert(saysItsDependencies<std::decay_t<decltype(known)>>,
                "an edit X needs EditDependencies dependencies(const X&, const DependencyFacts&)");
            return dependencies(known, row);
        },
        edit);
}

} // namespace core
