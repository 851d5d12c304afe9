// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

class QLabel;
class QProgressBar;

namespace ui {

class StudyOpener;

/// Shows the progress of long work: the name of the step, how far it is, about how long it will
/// take, and a button Abort.
class LoadingBar : public QFrame {
    Q_OBJECT

public:
    explicit LoadingBar(QWidget* parent = nullptr);

    /// Shows the work of this opener, and aborts it on request.
    void follow(StudyOpener& opener);

    /// Work that ends sooner is not shown. At first all is shown at once.
    void showAfter(int milliseconds) { m_later.setInterval(milliseconds); }

    void begin(const QString& what);
    void progress(const QString& step, int done, int total);
    /// The same for work of a single step.
    void percent(int done);
    void end();

Q_SIGNALS:
    void aborted();

private:
    QLabel* m_what;
    QLabel* m_step;
    QProgressBar* m_bar;
    QString m_stepName;
    QElapsedTimer m_clock; ///< started when the step began
    QTimer m_later;
};

} // namespace ui
