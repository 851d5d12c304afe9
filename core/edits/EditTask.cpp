// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditTask.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/open/OpenStroke.h"
#include "core/engine/EngineEdit.h"

#include <type_traits>

namespace core {

namespace {

template <class E>
concept saysItsEffects = requires
{
    static_cast<EditEffects (*)(const E&)>(&effects);
};

} // namespace

EditEffects effectsOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) {
            static_assert(saysItsEffects<std::decay_t<decltype(known)>>,
                "an edit X needs EditEffects effects(const X&)");
            return effects(known);
        },
        edit);
}

EditTask taskOf(const Edit& edit)
{
    return effectsOf(edit).task;
}

bool canStandOpen(const Edit& edit)
{
    return bool(effectsOf(edit).standsOpen);
}

bool changesDocumentOnly(const Edit& edit)
{
    return effectsOf(edit).onlyDocument;
}

bool takesVoxelsOrNothing(const Edit& edit)
{
    return effectsOf(edit).takesVoxelsOrNothing;
}

std::optional<DocumentChange::What> changedPart(const Edit& edit)
{
    return effectsOf(edit).changes;
}

Result<EngineEdit> engineEditOf(const Edit& edit, const Document& document)
{
    return visitEdit(
        [&document](const auto& known) -> Result<EngineEdit> {
            if constexpr (hasEngineEdit<std::decay_t<decltype(known)>>)
                return engineEdit(known, document);
            else
                return failure(ErrorCode::InvalidField, QStringLiteral("edit"),
                    Clause::saying("is not carried out by the engine alone"));
        },
        edit);
}

std::unique_ptr<OpenStroke> openStrokeOf(Edit& edit)
{
    return visitEdit(
        [](auto& known) -> std::unique_ptr<OpenStroke> {
            using E = std::decay_t<decltype(known)>;
            static_assert(!hasOpenStroke<E> || hasEngineEdit<E>,
                "what an open stroke returns is told to the engine, which must carry the edit out");
            if constexpr (hasOpenStroke<E>)
                return openStroke(known);
            else
                return nullptr;
        },
        edit);
}

OpenManner openMannerOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) -> OpenManner {
            if constexpr (hasOpenManner<std::decay_t<decltype(known)>>)
                return openManner(known);
            else
                return {};
        },
        edit);
}

} // namespace core
