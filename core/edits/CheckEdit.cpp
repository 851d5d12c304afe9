// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/AnyEdit.h"

#include <type_traits>

namespace core {

namespace {

template <class E>
concept saysWhetherItMayBeDone = requires
{
    static_cast<Result<void> (*)(const E&, const Document&)>(&check);
};

} // namespace

Result<void> checkAgainst(const Document& document, const Edit& edit)
{
    return visitEdit(
        [&document](const auto& known) {
            static_assert(saysWhetherItMayBeDone<std::decay_t<decltype(known)>>,
                "an edit X needs Result<void> check(const X&, const Document&)");
            return check(known, document);
        },
        edit);
}

} // namespace core
