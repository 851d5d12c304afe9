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

/// The study that the window shows: the open volume, or the first slice of one that is being
/// loaded; together with the caution about it in the message bar.
class ShownStudy : public QObject {
    Q_OBJECT

public:
    ShownStudy(Workspace& workspace, ViewGrid& views, MessageBar& messages, QObject* parent);

    /// Sets the first slice of what is being opened; null if nothing is, or no slice has arrived.
    void setEarly(const std::shared_ptr<const core::EarlySlice>& early);
    /// To be called when a study was closed: shows the early slice of its successor if there is
    /// one, and the views do not hold their pictures.
    void showEarlyAgain();
    /// The open volume, or the one of which a slice has arrived; null if the start page is shown.
    [[nodiscard]] const core::Volume* volume() const;
    void showCaution();

Q_SIGNALS:
    void earlyChanged(); ///< the early slice that is shown has changed

private:
    void showEarly(const std::shared_ptr<const core::EarlySlice>& early);

    Workspace& m_workspace;
    ViewGrid& m_views;
    MessageBar& m_messages;
    std::shared_ptr<const core::EarlySlice> m_early;
};

} // namespace ui
