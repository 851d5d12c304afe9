// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace ui {

/// What the window shows while nothing is open: open a study, the demonstration, or a recent one.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void showRecent(const QStringList& paths);

Q_SIGNALS:
    void openFolderAsked();
    void openFileAsked();
    void demonstrationAsked();
    void recentAsked(const QString& path);

private:
    QVBoxLayout* m_recent;
};

} // namespace ui
