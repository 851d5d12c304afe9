// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/window/GuardedApplication.h"

#include <QString>

#include <chrono>
#include <functional>
#include <vector>

namespace bench {

/// The program's own application, which also notes how long its thread was busy with which event.
/// An event that is handled while another one is counts as part of that.
class PacedApplication : public app::GuardedApplication {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds leastNoted{1};

    using GuardedApplication::GuardedApplication;

    struct Handled {
        Clock::time_point begin;
        Clock::time_point end;
        QString name; ///< who was told what: "ui::VolumeView, Paint"
    };
    /// The events that took leastNoted or more since this was called before.
    [[nodiscard]] std::vector<Handled> takeHandled();
    /// @param painted called whenever a widget has painted itself; none: nobody is told
    void setPainted(std::function<void(const QObject& widget)> painted);

    bool notify(QObject* receiver, QEvent* event) override;

private:
    int m_depth = 0; ///< of events within events
    std::vector<Handled> m_handled;
    std::function<void(const QObject&)> m_painted;
};

} // namespace bench
