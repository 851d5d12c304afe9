// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/masks/MaskOnVolume.h"
#include "core/metrics/MaskComparison.h"
#include "ui/tasks/LabelFetch.h"
#include "ui/workspace/Workspace.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace ui {

/// Compares the surface that is being refined, or else the active segment, with a segment of a
/// reference mask. It is computed on another thread whenever something has changed and no edit is
/// under way. The reference is not part of the session. GUI thread.
class LiveComparison : public QObject {
    Q_OBJECT

public:
    explicit LiveComparison(Workspace& workspace, QObject* parent = nullptr);

    /// Reads a mask of any format on another thread; then its segment of the compared one's name is
    /// the reference, or else its first, until another segment is active or one is chosen.
    void read(const QString& path);
    /// Takes the masks that the session has imported, as they came, for the reference: what has
    /// been changed since? The segment of the compared one's name is chosen, whichever that
    /// becomes.
    void takeImported();
    /// Whether there is such a mask among the steps that led to the present state.
    [[nodiscard]] bool canTakeImported() const;
    /// Whether the reference is what was imported.
    [[nodiscard]] bool isImported() const { return m_imported; }
    [[nodiscard]] bool isReading() const { return m_reading; }
    /// The reference file; empty if there is none, or if it is what was imported.
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] QStringList references() const; ///< names of the segments of the reference
    /// Of a file: for the compared segment, until the reference is another one.
    /// @param place index in references()
    void choose(int place);
    [[nodiscard]] int chosen() const { return m_chosen; } ///< −1: none
    /// The voxels of the reference that belongs to the active segment if it is from a file: the one
    /// chosen by hand for it, or that of its name, or the only one. What was imported differs where
    /// the user has mended it, which is no doubt. Null: none.
    [[nodiscard]] std::shared_ptr<const core::VoxelRuns> secondMask() const;

    struct Outcome {
        int segment = 0; ///< label of the segment that was compared
        /// true: the voxels inside its surface were compared, written back or not
        bool ofSurface = false;
        core::MaskComparison comparison;
    };
    /// The latest result; none if there is nothing to compare.
    [[nodiscard]] const std::optional<Outcome>& outcome() const { return m_outcome; }
    /// Whether the result is older than what the window shows.
    [[nodiscard]] bool isBehind() const;

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    using Masks = std::shared_ptr<const std::vector<core::MaskSegment>>;
    using Labels = std::shared_ptr<const std::vector<std::uint8_t>>;
    struct Job;

    void forget();
    void later();
    void look();
    void compare();
    void takeMasks(core::Result<core::MaskOnVolume>&& read);
    [[nodiscard]] const core::Segment* comparedSegment() const;
    [[nodiscard]] int placeFor(const core::Segment* segment) const;

    Workspace& m_workspace;
    QString m_path;
    Masks m_masks;
    int m_chosen = -1;
    std::map<int, int> m_byHand; ///< places in m_masks that were chosen, by label
    bool m_reading = false;
    bool m_imported = false;
    std::optional<Outcome> m_outcome;
    QTimer m_timer; ///< delay after the last change
    LabelFetch m_fetch;
    Labels m_labels; ///< the present label plane of the compared segment; null if not known
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
