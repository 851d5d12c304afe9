// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QImage>

class QLabel;

namespace ui {

/// What a step is called and, where there is one, a picture of what it looked like; floats over the
/// place it speaks of and takes no input.
class KeyframePopup : public QFrame {
    Q_OBJECT

public:
    explicit KeyframePopup(QWidget* parent);

    /// @param note what the picture shows, if it is not quite that step; may be empty
    void show(const QString& step, const QString& note, const QImage& picture);
    /// Above a point of the screen, inside the screen.
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
