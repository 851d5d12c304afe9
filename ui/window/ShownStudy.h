// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include <memory>

namespace core {
struct EarlySlice;
struct Volume;
} // namespace core

namespace ui {

class MessageBar;
class ViewGrid;
class Workspace;

/// What the window shows: the open volume, or the first slice of one that is on its way, with the
/// caution that it is shown with in the bar.
class ShownStudy : public QObject {
    Q_OBJECT

public:
    ShownStudy(Workspace& workspace, ViewGrid& views, MessageBar& messages, QObject* parent);

    /// Of what is being opened; null: nothing is, or nothing of it is there yet.
    void setEarly(const std::shared_ptr<const core::EarlySlice>& early);
    /// A study was closed: what takes its place may be on its way already.
    void showEarlyAgain();
    /// The open volume, or one of which a slice is there; null: the start page.
    [[nodiscard]] const core::Volume* volume() const;
    void showCaution();

Q_SIGNALS:
    void earlyChanged(); ///< as it is shown

private:
    void showEarly(const std::shared_ptr<const core::EarlySlice>& early);

    Workspace& m_workspace;
    ViewGrid& m_views;
    MessageBar& m_messages;
    std::shared_ptr<const core::EarlySlice> m_early;
};

} // namespace ui
