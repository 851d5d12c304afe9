// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/volume/Volume.h"

#include <QImage>
#include <QObject>
#include <QStringList>

namespace ui {

/// The middle slice of a volume in its own grey mapping, in true proportions, on black.
[[nodiscard]] QImage thumbnail(const core::LoadedVolume& volume, int size);

/// Makes small pictures of image files, one after the other, beside the GUI thread. What cannot be
/// read has no picture. Destroyed, it stops after the file at hand.
class ThumbnailLoader : public QObject {
    Q_OBJECT

public:
    ThumbnailLoader(const QStringList& files, int size);

Q_SIGNALS:
    void ready(int index, const QImage& picture);

private:
    core::Background m_worker;
};

} // namespace ui
