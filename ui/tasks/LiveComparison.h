// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/masks/MaskOnVolume.h"
#include "core/metrics/MaskComparison.h"
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
    struct Job;

    void forget();
    void later();
    void look();
    void compare();
    void takeMasks(core::Result<core::MaskOnVolume>&& read);
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
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
