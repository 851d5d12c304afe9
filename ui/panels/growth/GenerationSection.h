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

/// The generation bar of the open study's growth: follows a burst that runs, counts again after
/// every step, and scrubs. A drag is one step of undo, a shrinking; Escape takes it back.
class GenerationSection : public QWidget {
    Q_OBJECT

public:
    explicit GenerationSection(Workspace& workspace, QWidget* parent = nullptr);

    /// How a burst stands; not open: nothing is under way.
    void show(const core::GrowthProgress& progress);
    /// What the guard suspects; none: nothing any more.
    void showLeak(const std::optional<core::LeakAlarm>& alarm);
    /// Where a drag stands, in words; empty: there is none.
    [[nodiscard]] QString scrubText() const;

Q_SIGNALS:
    void scrubMoved();

private:
    void count();
    void showSizes();
    void begin();
    void goTo(int generation);
    void end(bool kept);

    Workspace& m_workspace;
    GenerationBar* m_bar = nullptr;
    QTimer m_countLater; ///< steps come in bursts, one count is enough for them
    std::vector<std::uint32_t> m_sizes; ///< of generations from 1 on, as last counted
    std::vector<std::uint32_t> m_added; ///< by the burst that runs
};

} // namespace ui
