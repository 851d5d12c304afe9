// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace ui {

/// A row in which the user names the file to write: a line for the path, and a button that opens a
/// file dialog. It starts in the offered folder,
/// or in the one that the user chose instead of it last.
class TargetRow : public QWidget {
    Q_OBJECT

public:
    /// @param name object name of the line
    /// @param folderKey key of the folder in the settings
    /// @param folder offered unless another one is remembered
    TargetRow(const QString& label, const QString& name, const QString& folderKey,
        const QString& folder, QWidget* parent = nullptr);

    /// Sets title and filter of the file dialog. The user may name an existing file.
    void askFor(const QString& title, const QString& filter);
    /// The path without surrounding blanks; empty if none is given.
    [[nodiscard]] QString path() const;
    void setPath(const QString& path);
    /// Changes the file name but not the folder; at first the folder is the remembered one.
    void setName(const QString& name);
    /// Remembers the folder for the next time if it is not the offered one.
    void remember() const;

Q_SIGNALS:
    void changed();

private:
    void browse();

    QString m_folderKey;
    QString m_folder;
    QString m_title;
    QString m_filter;
    QLineEdit* m_path;
    QPushButton* m_browse;
};

} // namespace ui
