// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/engine/EditEngine.h"
#include "core/history/History.h"
#include "core/volume/Volume.h"

#include <QString>

#include <map>
#include <set>
#include <variant>
#include <vector>

namespace test {

/// What a session must hold after each row of its history, worked out without any of its parts:
/// voxels by an oracle that is told one edit at a time, "undo only" by doing everything else again,
/// revised strokes by laying the cuts of all strokes over each other, the document by a few lines.
class HistoryTruth {
public:
    explicit HistoryTruth(core::LoadedVolume study);

    /// A row that was carried out, with its parent known already.
    void add(const core::HistoryRow& row);
    /// What differs between the truth at a row and a session that stands there; empty if nothing.
    [[nodiscard]] QString difference(core::RowId row, core::EditEngine& engine,
        const core::Document& document, const QByteArray& stateHash) const;

    /// For whoever thinks up what to do next.
    [[nodiscard]] const core::Document& documentAt(core::RowId row) const;
    /// Voxels that growths have added.
    [[nodiscard]] std::vector<glm::ivec3> grownVoxels(core::RowId row) const;
    /// Rows that changed voxels and count at a row, ascending.
    [[nodiscard]] std::vector<core::RowId> standingAt(core::RowId row) const;

private:
    using Bricks = std::map<core::BrickKey, std::vector<std::uint8_t>>; ///< that hold something
    using Cut = std::map<std::uint32_t, std::vector<std::uint8_t>>;
    struct State {
        Bricks bricks;
        core::Document document;
    };
    struct Stroke {
        core::RowId row = 0;
        core::SculptEdit form;
        bool removed = false;
    };

    [[nodiscard]] static core::SculptEdit formAfter(
        const core::Edit& drawn, const core::ReviseStroke& revise);
    [[nodiscard]] std::vector<core::RowId> path(core::RowId row) const;
    [[nodiscard]] std::set<core::RowId> standing(core::RowId row) const;
    void toggle(core::RowId row, bool stands, std::set<core::RowId>& rows) const;
    /// Seeds, growths, paint, deletions and what came from layers that stand, one after the other.
    [[nodiscard]] Bricks regrown(core::RowId row) const;
    [[nodiscard]] Bricks carvedUntil(core::RowId row);
    /// What writes layers otherwise than by cuts. @param at the row whose labels it met
    void writeLayer(const core::Edit& edit, core::RowId at, Bricks& carved) const;
    [[nodiscard]] Cut cutOf(const Stroke& stroke);
    void changeDocument(const core::Edit& edit, core::Document& document) const;
    /// What an edit makes of bricks, by an oracle of its own.
    [[nodiscard]] Bricks after(const Bricks& before, const core::EngineEdit& edit,
        const std::vector<core::EngineExtension>& extensions, std::uint32_t* generation,
        const core::Document* muting = nullptr) const;
    [[nodiscard]] Bricks grown(const Bricks& before, const core::Edit& edit, core::RowId parent,
        std::uint32_t* generation) const;

    core::LoadedVolume m_study;
    std::map<core::RowId, core::HistoryRow> m_rows;
    std::map<core::RowId, State> m_states;
    std::map<QByteArray, Cut> m_cuts; ///< by row and form
};

} // namespace test
