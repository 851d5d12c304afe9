// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/TaskThread.h"
#include "core/masks/MaskOnVolume.h"
#include "core/metrics/MaskComparison.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "ui/tasks/LabelFetch.h"
#include "ui/workspace/Workspace.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace ui {

/// How the surface that is being refined, or else the active segment, compares with a segment of a
/// mask's file that is held for the truth: worked out beside the window's work whenever it has
/// changed and nothing is under way. The reference is no part of the session. GUI thread.
class LiveComparison : public QObject {
    Q_OBJECT

public:
    explicit LiveComparison(Workspace& workspace, QObject* parent = nullptr);
    ~LiveComparison() override;

    /// Reads a mask of any format beside the window's work; its first segment is the reference
    /// then.
    void read(const QString& path);
    [[nodiscard]] bool isReading() const { return m_reading; }
    /// Of the file; empty: there is none.
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] QStringList references() const; ///< names
    /// @param place in references()
    void choose(int place);
    [[nodiscard]] int chosen() const { return m_chosen; } ///< −1: none

    struct Outcome {
        int segment = 0; ///< label of what was compared
        bool ofSurface = false; ///< the voxels inside its surface, written back or not
        core::MaskComparison comparison;
    };
    /// The last one; none: there is nothing to compare.
    [[nodiscard]] const std::optional<Outcome>& outcome() const { return m_outcome; }
    /// It is behind what the window shows.
    [[nodiscard]] bool isBehind() const;

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    using Masks = std::shared_ptr<const std::vector<core::MaskSegment>>;
    using Labels = std::shared_ptr<const std::vector<std::uint8_t>>;
    /// What the thread works on; it belongs to it until it is done.
    struct Job {
        Outcome outcome;
        Labels labels; ///< of the segment's plane, x fastest; null: the surface's voxels count
        core::SimplexMesh mesh;
        Masks masks;
        std::size_t reference = 0; ///< place in masks
        core::VolumeGeometry geometry;
        core::Progress progress;
    };

    void forget();
    void later();
    void look();
    void compare();
    void takeMasks(const QString& path, core::Result<core::MaskOnVolume>&& read);
    void take(const std::shared_ptr<Job>& job, const core::Result<core::MaskComparison>& done);
    [[nodiscard]] const core::Segment* comparedSegment() const;

    Workspace& m_workspace;
    QString m_path;
    Masks m_masks;
    int m_chosen = -1;
    bool m_reading = false;
    std::optional<Outcome> m_outcome;
    QTimer m_timer; ///< until things have settled
    LabelFetch m_fetch;
    Labels m_labels; ///< of the compared segment's plane as they are now; null: not known
    std::shared_ptr<Job> m_job;
    core::TaskThread m_thread; ///< last: it uses all of the above
};

} // namespace ui
