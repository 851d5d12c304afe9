// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sessionfile/AuditReport.h"

#include <QString>

#include <vector>

namespace ui {

struct AuditSegments;

/// The texts of an audit report, independent of the output format.
struct AuditTexts {
    struct Fact {
        QString name;
        QString value;
        bool isHash = false;
    };
    struct Step {
        QString number;
        QString when; ///< UTC
        QString who;
        QString what;
        QString note; ///< "undone", "old future, behind step 5"; empty: it stands
        QString howMuch;
        QString hash; ///< the first digits of the hash
        bool stands = true;
    };
    struct Picture {
        QString caption;
        QString sha256;
        QByteArray png;
    };

    struct Segment {
        QString name;
        QString size; ///< in mL and voxels, or in voxels alone; "no voxel"
        QString change; ///< since it was imported; empty: it was not
    };

    QString title;
    QString subtitle;
    std::vector<Fact> study;
    std::vector<Fact> session;
    bool sound = false;
    QString verdict; ///< one line
    QString explanation;
    QString aboutSegments; ///< empty: the report says nothing of them
    std::vector<Segment> segments;
    std::vector<Picture> changes; ///< of segments that were imported
    QString aboutChanges;
    std::vector<Step> steps;
    QString noSteps; ///< where there are none
    std::vector<Picture> pictures;
    QString aboutPictures;
    QString noPictures; ///< where there are none
    QString footer;

    /// @param segments null: they are not known
    [[nodiscard]] static AuditTexts of(
        const core::AuditReport& report, const AuditSegments* segments = nullptr);
};

} // namespace ui
