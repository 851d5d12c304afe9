// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"

#include "core/edits/answers/EditEffects.h"
#include "core/edits/kinds/AnyEdit.h"

#include <type_traits>
#include <utility>

namespace core {

namespace {

template <class E>
concept saysWhatItChanges = requires
{
    static_cast<Result<bool> (*)(const E&, Document&)>(&apply);
};

} // namespace

Result<bool> applyToDocument(const Edit& edit, Document& document)
{
    return visitEdit(
        [&document](const auto& known) {
            static_assert(saysWhatItChanges<std::decay_t<decltype(known)>>,
                "an edit X needs Result<bool> apply(const X&, Document&)");
            const Result<bool> applied = apply(known, document);
            if (applied && document.surface && effects(known).writesTo == document.surface->segment)
                document.surface->differs = true;
            return applied;
        },
        edit);
}

Document initialDocument(Volume volume)
{
    Document document;
    document.volumes.push_back(std::move(volume));
    document.layers.push_back({.id = 1, .name = QStringLiteral("Sculpt 1")});
    document.growths.push_back({.plane = 0, .generation = 0});
    return document;
}

} // namespace core
