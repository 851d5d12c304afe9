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

/// Handles the loss of the graphics driver's context (ContextLost) in the window, wherever it is
/// noticed: the study is closed, complete on disk, and the user is told why and offered to open it
/// again in the same state. The engine is made again by whatever is opened next (SessionOpening).
class LostContext : public QObject {
    Q_OBJECT

public:
    /// @param closeStudy closes the study of the window; an error means that the user keeps it
    /// because of steps that are on no disk
    LostContext(
        ui::MainWindow& window, std::function<core::Result<void>()> closeStudy, QObject* parent);

private:
    struct Offer {
        QString sentence;
        QString session; ///< its file; it may not exist, if no step had been done
        QString study;
        QString series; ///< with the repair appended
    };

    void note(const core::Error& error);
    void close(const core::Error& error);
    void show();
    void openAgain();

    ui::MainWindow& m_window;
    std::function<core::Result<void>()> m_closeStudy;
    bool m_isClosing = false; ///< or is about to close
    std::optional<Offer> m_offer; ///< the present offer, until something is opened
};

} // namespace app
