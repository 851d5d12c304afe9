// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QImage>

class QLabel;

namespace ui {

/// A popup with the name of a step and, if there is one, a picture of what it looked like. It
/// floats over the step and takes no input.
class KeyframePopup : public QFrame {
    Q_OBJECT

public:
    explicit KeyframePopup(QWidget* parent);

    /// @param note which step the picture shows, if it is another one; may be empty
    void show(const QString& step, const QString& note, const QImage& picture);
    /// Moves it above a point of the screen, kept inside the screen.
    void moveAbove(const QPoint& global);

    [[nodiscard]] const QImage& picture() const { return m_shown; }
    [[nodiscard]] QString words() const;

private:
    QImage m_shown;
    QLabel* m_picture = nullptr;
    QLabel* m_step = nullptr;
    QLabel* m_note = nullptr;
};

} // namespace ui
