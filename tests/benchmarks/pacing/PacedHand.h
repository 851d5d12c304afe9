// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QEventLoop>
#include <QPointF>
#include <QTimer>

#include <cstddef>
#include <cstdint>

class QAbstractButton;

namespace ui {
class ImageView;
class MainWindow;
} // namespace ui

namespace bench {

class PacingRecorder;

/// A hand that works in the window by a script: it orbits, drills, grows step by step, scrubs
/// through slices, and undoes and redoes, each for as long. All that it does reaches the window as
/// events that lie in the queue, as those of a mouse do; so its own work holds nobody up.
class PacedHand {
public:
    /// The study is open, and its active segment has seeds.
    PacedHand(ui::MainWindow& window, PacingRecorder& recorder);
    PacedHand(const PacedHand&) = delete;
    PacedHand& operator=(const PacedHand&) = delete;

    /// Runs the event loop until all is done.
    void work(double secondsOfEach);

private:
    enum class Phase { Orbit, Drill, Grow, Scrub, Undo };

    void tick();
    void begin(Phase phase);
    void end();
    void moveOn(double seconds);
    void drill(double seconds);
    void grow();
    void scrub();
    void undoOrRedo(double seconds);
    /// Whether the 3D view has shown a picture since this was true before, but not as soon as a key
    /// that is held repeats itself; or hardly any time is left to wait for one.
    [[nodiscard]] bool hasSeen();

    void press(ui::ImageView& view, const QPointF& at);
    void release();

    ui::MainWindow& m_window;
    PacingRecorder& m_recorder;
    QAbstractButton* m_step = nullptr; ///< of the growth panel
    QEventLoop m_loop;
    QTimer m_tick;
    Phase m_phase = Phase::Orbit;
    double m_seconds = 0.0; ///< of each phase
    QElapsedTimer m_sinceBegin; ///< of the phase
    QElapsedTimer m_sinceAsked;
    int m_seenThen = 0;
    std::size_t m_rowsAtFirst = 0;
    bool m_undoes = true;
    int m_ticks = 0; ///< of the phase
    int m_stroke = 0; ///< of the drill
    ui::ImageView* m_held = nullptr; ///< the button is down there
    QPointF m_at;
};

} // namespace bench
