// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {
struct GrowthProgress;
struct LeakAlarm;
} // namespace core

namespace ui {

class GenerationBar;
class Workspace;

/// The generation bar for the growth of the open study: it follows a running burst, counts the
/// generations again after every step, and lets the user drag. A drag is one step of undo (a
/// shrinking); Escape takes it back.
class GenerationSection : public QWidget {
    Q_OBJECT

public:
    explicit GenerationSection(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows the progress of a burst. If none is open nothing is under way.
    void show(const core::GrowthProgress& progress);
    /// Shows what the leak guard suspects; none: nothing any more.
    void showLeak(const std::optional<core::LeakAlarm>& alarm);
    /// Where a drag stands, in words; empty without a drag.
    [[nodiscard]] QString scrubText() const;

Q_SIGNALS:
    void scrubMoved();

private:
    void count();
    void showSizes();
    void showScrubbable();
    void begin();
    void goTo(int generation);
    void end(bool kept);

    void followPlane();

    Workspace& m_workspace;
    std::uint8_t m_plane = 0; ///< the label plane whose growth is shown
    GenerationBar* m_bar = nullptr;
    QTimer m_countLater; ///< counts once after several steps in quick succession
    std::vector<std::uint32_t> m_sizes; ///< voxels of each generation from 1 on, as last counted
    std::vector<std::uint32_t> m_added; ///< voxels added by each generation of the running burst
};

} // namespace ui
