// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/volume/Volume.h"

#include <QImage>
#include <QObject>
#include <QStringList>

namespace ui {

/// The middle slice of a volume with the volume's own window, in true proportions, on black.
/// @param size side of the square picture, pixels
[[nodiscard]] QImage thumbnail(const core::LoadedVolume& volume, int size);

/// Makes small pictures of image files, one after the other, on another thread. A file that cannot
/// be read gets no picture. The destructor stops it after the current file.
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
