// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QJsonObject>

#include <optional>

namespace core {

/// What a session was made on: where it was, and how to know it again. No patient's name.
struct SessionSource {
    QString path;
    QString format;
    QString studyUid;
    QString seriesUid;
    // To be told apart by people; empty where the study or an older session does not say.
    QString seriesDescription;
    QString modality;
    QString studyDate; ///< YYYY-MM-DD
    QString repair; ///< how its series was repaired on loading (Volume::repair); empty: not at all
    int time = 0; ///< which point of a series in time it is, from 1; 0: of none, or it does not say
    glm::ivec3 size{0};
    glm::dmat4 indexToWorld{1.0};
    QByteArray voxelsSha256; ///< hex; empty if the loader did not tell
    QByteArray codesSha256; ///< hex; only where the values do not follow from the codes

    [[nodiscard]] static SessionSource of(const Volume& volume);
    [[nodiscard]] QJsonObject toJson() const;
    [[nodiscard]] static std::optional<SessionSource> fromJson(const QJsonObject& json);

    /// Why @p volume is not the one; empty if it is.
    [[nodiscard]] QString differenceFrom(const Volume& volume) const;
};

} // namespace core
