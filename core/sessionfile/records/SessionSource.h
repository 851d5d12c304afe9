// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/volume/Volume.h"

#include <QJsonObject>

#include <optional>

namespace core {

/// The study on which a session was made: where it was, and how to recognise it. No patient's name.
struct SessionSource {
    QString path;
    QString format;
    QString studyUid;
    QString seriesUid;
    // For people to tell studies apart; empty if the study or an older session does not have them.
    QString seriesDescription;
    QString modality;
    QString studyDate; ///< YYYY-MM-DD
    QString repair; ///< how the series was repaired on loading (Volume::repair); empty: not at all
    int time = 0; ///< the point of a series in time, from 1; 0: none, or unknown
    glm::ivec3 size{0};
    glm::dmat4 indexToWorld{1.0};
    QByteArray voxelsSha256; ///< hex; empty if the loader did not compute it
    QByteArray codesSha256; ///< hex; only where the values do not follow from the codes

    [[nodiscard]] static SessionSource of(const Volume& volume);
    [[nodiscard]] QJsonObject toJson() const;
    [[nodiscard]] static std::optional<SessionSource> fromJson(const QJsonObject& json);

    /// The reason why @p volume is another one; empty if it is the same.
    [[nodiscard]] Clause differenceFrom(const Volume& volume) const;
};

} // namespace core
