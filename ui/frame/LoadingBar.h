// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QFrame>

class QLabel;
class QProgressBar;

namespace ui {

class StudyOpener;

/// Long work: the step's name, how far it is, about how long it will take, and Abort.
class LoadingBar : public QFrame {
    Q_OBJECT

public:
    explicit LoadingBar(QWidget* parent = nullptr);

    /// Shows what it does, and aborts it.
    void follow(StudyOpener& opener);

    void begin(const QString& what);
    void progress(const QString& step, int done, int total);
    void end();

Q_SIGNALS:
    void aborted();

private:
    QLabel* m_what;
    QLabel* m_step;
    QProgressBar* m_bar;
    QString m_stepName;
    QElapsedTimer m_clock; ///< since the step began
};

} // namespace ui
