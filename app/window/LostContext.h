// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace ui {
class MainWindow;
}

namespace app {

/// What the window does where the graphics driver loses its context (ContextLost), however that
/// comes out: the study is closed, whole on disk, and the user is told why and offered to open it
/// again where it stood. The engine is made anew by whatever is opened next (SessionOpening).
class LostContext : public QObject {
    Q_OBJECT

public:
    /// @param closeStudy of the window; its error: the user stays with what is on no disk
    LostContext(
        ui::MainWindow& window, std::function<core::Result<void>()> closeStudy, QObject* parent);

private:
    struct Offer {
        QString sentence;
        QString session; ///< its file; it may be gone, where no step had been done
        QString study;
        QString series; ///< with the repair behind it
    };

    void note(const core::Error& error);
    void close(const core::Error& error);
    void show();
    void openAgain();

    ui::MainWindow& m_window;
    std::function<core::Result<void>()> m_closeStudy;
    bool m_isClosing = false; ///< or about to
    std::optional<Offer> m_offer; ///< that stands, until something is opened
};

} // namespace app
