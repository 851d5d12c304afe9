// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QTimer>

#include <functional>

class QLabel;
class QPushButton;
class QToolButton;

namespace ui {

class Workspace;

/// Shows one sentence at the top of the views: what happened, to what, and what to do; with a
/// button if the program can help. Hidden while there is no message. It lies over the pictures, so
/// a notice that asks for nothing disappears by itself; a caution, an error and a message with a
/// button stay until they are closed.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Notice, Caution, Error };

    explicit MessageBar(QWidget* parent = nullptr);

    void show(Kind kind, const QString& sentence);
    void show(Kind kind, const QString& sentence, const QString& button, std::function<void()> run);
    /// Sets the tool tips of the buttons of the message that is shown; the next message has none.
    /// @param close tool tip of the ×, instead of the usual one
    void setTips(const QString& button, const QString& close);
    /// Declares that the message that is shown is about the last step, which its button undoes: it
    /// is dismissed as soon as another step is made, or that one is undone.
    void dismissAtNextStep(Workspace& workspace);
    void dismiss();
    [[nodiscard]] QString sentence() const;
    /// How long a notice without a button stays, unless the pointer rests on it.
    static constexpr int noticeMs = 12'000;
    void setNoticeTime(int milliseconds) { m_leaving.setInterval(milliseconds); }

private:
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_button;
    QToolButton* m_close;
    std::function<void()> m_run;
    QTimer m_leaving; ///< runs while a notice is shown that disappears by itself
};

} // namespace ui
