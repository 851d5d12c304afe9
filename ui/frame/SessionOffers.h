// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/sessionfile/SessionPreview.h"

#include <QWidget>

#include <vector>

class QVBoxLayout;

namespace ui {

/// The part of the start page that lists the sessions in a folder which can be continued, newest
/// first, one card each. They are read on another thread and never changed. Sessions that are open
/// in another window, hold no step or cannot be read are left out.
class SessionOffers : public QWidget {
    Q_OBJECT

public:
    static constexpr int shownAtFirst = 6;

    explicit SessionOffers(QWidget* parent = nullptr);

    /// Lists the sessions of a folder; an empty name clears the list.
    void showFolder(const QString& folder);
    [[nodiscard]] int count() const { return int(m_offers.size()); }

    /// "recovered: 41 steps, last at 14:02"
    [[nodiscard]] static QString stateText(
        const core::SessionPreview& preview, const QDateTime& now);
    /// The study of the session: series, modality and date, or the study's file or folder if these
    /// are not known.
    [[nodiscard]] static QString studyText(const core::SessionPreview& preview);

Q_SIGNALS:
    void openRequested(const QString& sessionFile);
    void changed(); ///< count() or the list has changed

private:
    void showOffers(std::vector<core::SessionPreview> offers);
    void build();
    [[nodiscard]] QWidget* card(const core::SessionPreview& preview);
    void discard(const core::SessionPreview& preview);

    QString m_folder;
    std::vector<core::SessionPreview> m_offers;
    bool m_showAll = false;
    QVBoxLayout* m_cards;
    core::Background m_reader; ///< last: it uses all of the above
};

} // namespace ui
