// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QBoxLayout;
class QVBoxLayout;

namespace ui {

class SessionOffers;

/// What the window shows while nothing is open: buttons to open a study, the demonstration study or
/// a recent study, and sessions to continue.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void showRecent(const QStringList& paths);
    /// Lists the sessions in a folder.
    void showSessions(const QString& folder);

Q_SIGNALS:
    void openFolderRequested();
    void openFileRequested();
    void demonstrationRequested();
    void recentRequested(const QString& path);
    void sessionRequested(const QString& sessionFile);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    QBoxLayout* m_columns; ///< the buttons, with the sessions beside or below them
    QWidget* m_choices;
    QVBoxLayout* m_recent;
    SessionOffers* m_sessions;
};

} // namespace ui
