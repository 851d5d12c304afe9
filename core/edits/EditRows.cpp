// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditRows.h"

#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/EditParts.h"

#include <iterator>
#include <type_traits>
#include <utility>

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

/// Says that an edit kept to an editable range, before what it changed. Edits without one are
/// called as ever.
RowTitle limited(RowTitle title, const Edit& edit)
{
    const std::optional<EditableRange>* const range = editableRangeOf(edit);
    if (range && isLimited(*range) && !title.then.empty())
        title.then.insert(
            std::prev(title.then.end()), RowTitle{.code = RowTitleCode::WithinLimits});
    return title;
}

} // namespace

RowTitle titleOf(const Edit& edit, const RowFacts& row)
{
    RowTitle title = visitEdit(
        [&row](const auto& known) {
            static_assert(saysItsTitle<std::decay_t<decltype(known)>>,
                "an edit X needs RowTitle rowTitle(const X&, const RowFacts&)");
            return rowTitle(known, row);
        },
        edit);
    return limited(std::move(title), edit);
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
