// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <QString>

#include <concepts>
#include <optional>

namespace core {

/// Who carries an edit out.
enum class EditTask {
    Document, ///< nobody else: lists and what they say
    Engine, ///< the engine, and the document with it where it says so (changedPart())
    Surface, ///< the surface that is refined; writing back goes on to the engine
    Chunks, ///< the chunks around a segment
    History, ///< older rows are taken back or changed
};

/// Segments that may have their first voxels, or seeds, from an edit.
struct FilledSegments {
    std::optional<int> label{};
    QString name{}; ///< those that are called so; empty: none
    bool added = false; ///< those that it adds to the document
};

/// What can be said of an edit before it is carried out. The first two have to be said of each.
struct EditEffects {
    EditTask task;
    /// Whether it can be begun, and told bit by bit until it ends: what is under the pen, a growth
    /// that is watched, a preview. All others are carried out whole.
    bool standsOpen;
    /// Which list of the document it changes; none if it changes voxels only.
    std::optional<DocumentChange::What> changes{};
    /// Whether it changes the document, and no voxel.
    bool onlyDocument = false;
    /// Whether it does nothing at all, in the document neither, where it changes no voxel.
    bool takesVoxelsOrNothing = false;
    /// The label whose voxels it is about: of a surface around that segment the surface differs
    /// from then on. What growth does is not known before; nor what others lose.
    std::optional<int> writesTo{};
    /// Who will have to be coded where it is exported with a code.
    FilledSegments fills{};
    /// Whether it names places of one study, or rows of one history, and so means nothing in a
    /// recipe for another.
    bool boundToStudy = false;
};

/// Whether the engine has a command for it.
template <class E>
concept hasEngineEdit = requires(const E& edit, const Document& document)
{
    {
        engineEdit(edit, document)
        } -> std::same_as<Result<EngineEdit>>;
};

/// The task of what the engine carries out.
template <class E> [[nodiscard]] constexpr EditTask engineTask()
{
    static_assert(hasEngineEdit<E>,
        "an edit X that the engine carries out needs Result<EngineEdit> engineEdit(const X&, const "
        "Document&)");
    return EditTask::Engine;
}

/// Of what is carried out on the document alone.
[[nodiscard]] inline EditEffects documentEffects(
    DocumentChange::What changes, bool boundToStudy = false)
{
    return {.task = EditTask::Document,
        .standsOpen = false,
        .changes = changes,
        .onlyDocument = true,
        .boundToStudy = boundToStudy};
}

} // namespace core
