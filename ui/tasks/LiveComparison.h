// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/history/History.h"
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

    /// Reads a mask of any format on another thread. Its segment with the name of the compared one
    /// becomes the reference, or else its first segment. That holds until another segment becomes
    /// active or choose() is called.
    void read(const QString& path);
    /// Takes the imported masks, as they were read, as the reference, to show what was changed
    /// since: for each segment that was imported, the newest mask of it. Whichever segment is
    /// compared, its own is chosen, whatever it is called. When the session comes to a state with
    /// other imports, their masks become the reference.
    void takeImported();
    /// Whether an import of a mask is among the steps that led to the present state.
    [[nodiscard]] bool canTakeImported() const;
    /// Whether the reference is what was imported, be it nothing in the present state.
    [[nodiscard]] bool isImported() const { return m_imported; }
    [[nodiscard]] bool isReading() const { return m_reading; }
    /// The reference file; empty if there is none, or if it is what was imported.
    [[nodiscard]] const QString& path() const { return m_path; }
    /// Names of the segments of the reference: what was imported has the names of today.
    [[nodiscard]] QStringList references() const;
    /// Chooses which segment of the reference is compared. If the reference is a file, the choice
    /// is kept for the compared segment until the reference is another one.
    /// @param place index in references()
    void choose(int place);
    [[nodiscard]] int chosen() const { return m_chosen; } ///< −1: none
    /// The voxels of the reference for the active segment, if the reference is a file: the segment
    /// chosen by hand, or the one of its name, or the only one. Null otherwise: an imported mask
    /// differs where the user has mended it, and that is no doubt.
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
    void followCompared();
    void later();
    void look();
    void compare();
    void fetchImported();
    void followImports();
    /// @param labels of the segments that the masks were imported into; empty: of a file
    void takeMasks(core::Result<std::vector<core::MaskSegment>>&& read, std::vector<int> labels);
    [[nodiscard]] const core::Segment* comparedSegment() const;
    [[nodiscard]] int comparedLabel() const;
    [[nodiscard]] bool knowsLabelsOf(const core::Segment& segment) const;
    [[nodiscard]] int placeFor(const core::Segment* segment) const;

    Workspace& m_workspace;
    QString m_path;
    Masks m_masks;
    std::vector<int> m_importedLabels; ///< one for each of m_masks, if they are imported ones
    std::vector<core::RowId> m_importRows; ///< whose masks these are
    int m_chosen = -1;
    std::map<int, int> m_byHand; ///< places in m_masks that were chosen, by label
    bool m_reading = false;
    bool m_imported = false;
    std::optional<Outcome> m_outcome;
    QTimer m_timer; ///< delay after the last change
    LabelFetch m_fetch;
    Labels m_labels; ///< a present label plane; null if not known
    std::uint8_t m_labelsPlane = 0; ///< which one it is
    int m_followed = 0; ///< the label to which the reference was chosen last; 0: none
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
