// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QMenu;
class QWidget;

namespace ui {

/// Everything that the user can tell the window to do, by name, with text, shortcut keys, tool tip,
/// and a test whether it is possible. All menus and buttons show these actions; no other code makes
/// any.
class Actions : public QObject {
    Q_OBJECT

public:
    struct Entry {
        QString id; ///< "edit.undo"
        QString text;
        QList<QKeySequence> keys{};
        QString icon{}; ///< resources/icons; may be empty
        QString tip{}; ///< may be empty
        std::function<void()> run;
        std::function<bool()> possible{}; ///< asked by refresh(); none: always
        std::function<bool()> checked{}; ///< makes it checkable; asked by refresh()
        std::function<QString()> currentText{}; ///< replaces `text` on refresh(); none: fixed
    };

    /// Shortcut keys work anywhere in @p window.
    explicit Actions(QWidget& window);

    QAction& add(Entry entry);
    [[nodiscard]] QAction& operator[](const QString& id) const;
    /// In the order they were added.
    [[nodiscard]] std::vector<QAction*> all() const;
    /// Fills a menu with these actions in this order; an empty id is a separator. Whenever the menu
    /// opens, they are refreshed.
    void fill(QMenu& menu, const QStringList& ids);
    /// Updates every action: whether it is possible, whether it is checked, and its present text.
    void refresh();

private:
    QWidget& m_window;
    std::vector<Entry> m_entries;
    QHash<QString, QAction*> m_actions;
};

} // namespace ui
