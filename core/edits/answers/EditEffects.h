// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/answers/Opening.h"

#include <QString>

#include <concepts>
#include <cstdint>
#include <optional>

namespace core {

/// The part of the program that carries an edit out.
enum class EditTask {
    Document, ///< no other part: it changes lists of the document and their entries
    Engine, ///< the engine, and the document too if changedPart() says so
    Surface, ///< the surface that is refined; writing back also uses the engine
    Chunks, ///< the chunks around a segment
    /// The side thread computes parts or shape of a segment from labels or values, then the engine
    /// writes.
    Islands,
    History, ///< older rows are taken back or changed
};

/// A label, or none. It has no default, so it must be stated wherever one is made.
struct StatedLabel : std::optional<int> {
    StatedLabel(int label)
        : std::optional<int>(label)
    {
    }
    StatedLabel(std::nullopt_t) { }
    StatedLabel(std::optional<int> label)
        : std::optional<int>(label)
    {
    }
};

/// The segments that an edit itself adds, and what of them is known before it is carried out.
enum class AddedSegments {
    None,
    Known, ///< in what label planes, and how many
    UnknownPlane, ///< which label plane has room is found when it is carried out
    UnknownNumber, ///< how many there are is found when it is carried out
};

/// Segments that may have their first voxels, or seeds, from an edit.
struct FilledSegments {
    StatedLabel label;
    std::optional<int> other{}; ///< a second label that receives voxels
    QString name{}; ///< those that are called so; empty: none
    AddedSegments added = AddedSegments::None; ///< these, too
};
/// No segment has its first voxels, or seeds, from it.
inline const FilledSegments fillsNothing{.label = std::nullopt};

/// What is known of an edit before it is carried out. `task`, `standsOpen` and `fills` must be
/// given for each edit; without `fills` it does not compile.
struct EditEffects {
    EditTask task;
    /// Whether it can be begun and then continued until it ends. All other edits are carried out
    /// whole.
    Opening standsOpen;
    /// The list of the document that it changes; none if it changes only voxels.
    std::optional<DocumentChange::What> changes{};
    /// It changes the document and no voxel.
    bool onlyDocument = false;
    /// It does nothing, not even in the document, if it changes no voxel.
    bool takesVoxelsOrNothing = false;
    /// The label whose voxels it is about; a surface around that segment differs from it
    /// afterwards. What a growth changes is not known in advance, nor what other segments lose.
    std::optional<int> writesTo{};
    /// The segments that may get their first voxels or seeds from it. Recipes check that these have
    /// a code before they are exported to a format that needs codes.
    FilledSegments fills;
    /// It refers to places of one study or to rows of one history, so it means nothing in a recipe
    /// for another study.
    bool boundToStudy = false;
    /// The label plane whose growth has another generation afterwards; none: no growth has.
    std::optional<std::uint8_t> movesGenerationOf{};
};

/// Whether there is a command of the engine for this kind of edit.
template <class E>
concept hasEngineEdit = requires(const E& edit, const Document& document)
{
    {
        engineEdit(edit, document)
        } -> std::same_as<Result<EngineEdit>>;
};

/// The task of an edit that the engine carries out.
template <class E> [[nodiscard]] constexpr EditTask engineTask()
{
    static_assert(hasEngineEdit<E>,
        "an edit X that the engine carries out needs Result<EngineEdit> engineEdit(const X&, const "
        "Document&)");
    return EditTask::Engine;
}

/// The effects of an edit of the document alone.
[[nodiscard]] inline EditEffects documentEffects(
    DocumentChange::What changes, bool boundToStudy = false)
{
    return {.task = EditTask::Document,
        .standsOpen = false,
        .changes = changes,
        .onlyDocument = true,
        .fills = fillsNothing,
        .boundToStudy = boundToStudy};
}

/// The effects of an edit that gives voxels to a segment or takes some from it, which the side
/// thread computes first.
[[nodiscard]] inline EditEffects workedOutEffects(
    int segment, bool boundToStudy, Opening standsOpen = false)
{
    return {.task = EditTask::Islands,
        .standsOpen = standsOpen,
        .writesTo = segment,
        .fills = {.label = segment},
        .boundToStudy = boundToStudy};
}

} // namespace core
