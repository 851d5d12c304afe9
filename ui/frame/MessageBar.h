// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <functional>

class QLabel;
class QPushButton;

namespace ui {

/// Shows one sentence above the views: what happened, to what, and what to do; with a button if the
/// program can help. Hidden while there is no message.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Notice, Caution, Error };

    explicit MessageBar(QWidget* parent = nullptr);

    void show(Kind kind, const QString& sentence);
    void show(Kind kind, const QString& sentence, const QString& button, std::function<void()> run);
    void dismiss();
    [[nodiscard]] QString sentence() const;

private:
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_button;
    std::function<void()> m_run;
};

} // namespace ui
