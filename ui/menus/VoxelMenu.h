// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPoint>

#include <glm/glm.hpp>

#include <functional>
#include <utility>

class QMenu;
class QWidget;

namespace ui {

struct PointedVoxel;
class Workspace;

/// The context menu of a view about the voxel under the pointer. Its entries remove the island of
/// the segment at that voxel, keep only this island, or give it to another segment; PlaceMenu.h
/// adds more. The session is asked first which segments the voxel belongs to, so the menu opens a
/// moment later. A press, a wheel turn or a key in the meantime, or another request, withdraws it.
/// Outside the volume the menu is about the view alone.
class VoxelMenu : public QObject {
    Q_OBJECT

public:
    /// Begins a request and withdraws an earlier one of the same view. The object deletes itself
    /// when the request has ended.
    /// @param view owns this object and the menu
    /// @param at place of the menu in screen pixels
    VoxelMenu(Workspace& workspace, QWidget& view, const QPoint& at);

    /// Opens the menu when the session has answered. Outside the volume it acts like
    /// openElsewhere().
    /// @param placeLps LPS mm; the nearest voxel is meant
    void openAbout(const glm::dvec3& placeLps);
    /// Opens at once a menu that is about no voxel: the window presets and the view's own entries.
    void openElsewhere();
    /// Sets the function that adds the view's own entries below those about the voxel.
    void addAtEnd(std::function<void(QMenu&)> more) { m_more = std::move(more); }
    [[nodiscard]] bool withdrawn() const { return m_withdrawn; }
    void withdraw();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void open(const PointedVoxel& pointed);
    /// @return null while a menu must not open: a mouse button is down, or a dialog or another menu
    /// is open
    [[nodiscard]] QMenu* newMenu(const char* name);
    void addEntries(QMenu& menu, int label, const glm::dvec3& placeLps) const;
    [[nodiscard]] QString whyNot(int label) const;

    Workspace& m_workspace;
    QWidget& m_view;
    QPoint m_at;
    std::function<void(QMenu&)> m_more; ///< empty: nothing
    bool m_withdrawn = false;
};

} // namespace ui
