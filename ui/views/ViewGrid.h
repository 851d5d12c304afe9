// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/views/FrameInbox.h"
#include "ui/views/SliceView.h"
#include "ui/views/VolumeView.h"

#include <QWidget>

#include <array>
#include <memory>

class QGridLayout;

namespace ui {

/// The four linked views: axial and 3D above, sagittal and coronal below; or one of them alone.
class ViewGrid : public QWidget {
    Q_OBJECT

public:
    explicit ViewGrid(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] SliceView& axial() const { return *m_axial; }
    [[nodiscard]] SliceView& sagittal() const { return *m_sagittal; }
    [[nodiscard]] SliceView& coronal() const { return *m_coronal; }
    [[nodiscard]] VolumeView& volume() const { return *m_volume; }
    [[nodiscard]] std::array<ImageView*, 4> views() const;
    /// The view that has the keyboard, or had it last.
    [[nodiscard]] ImageView& current() const { return *m_current; }

    /// One view alone; null: all four.
    void maximise(ImageView* view);
    [[nodiscard]] ImageView* maximised() const { return m_maximised; }
    void resetViews();
    /// A slice of a study that is on its way, until one is open; null: none. @return whether one of
    /// the views looks at it: others have nothing to show yet
    bool showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early);
    [[nodiscard]] const core::EarlySlice* earlySlice() const { return m_early.get(); }
    /// Every view on the screen shows its finest picture of what is asked for.
    [[nodiscard]] bool refined() const;

Q_SIGNALS:
    void layoutChanged();
    void pictureChanged(); ///< some view's quality changed
    void frameTimed(double milliseconds);

private:
    void give(const gpu::Frame& frame);

    FrameInbox m_inbox;
    std::shared_ptr<const core::EarlySlice> m_early;
    SliceView* m_axial;
    VolumeView* m_volume;
    SliceView* m_sagittal;
    SliceView* m_coronal;
    ImageView* m_current;
    ImageView* m_maximised = nullptr;
};

} // namespace ui
