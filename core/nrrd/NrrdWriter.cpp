// SPDX-License-Identifier: Apache-2.0
#include "core/nrrd/NrrdWriter.h"

#include "core/voxelfile/PackedOutput.h"

namespace core {

namespace {

/// As many digits as a double needs to be itself again.
QByteArray exactly(double value)
{
    return QByteArray::number(value + 0.0, 'g', 17);
}

QByteArray inBrackets(const glm::dvec3& vector)
{
    return '(' + exactly(vector.x) + ',' + exactly(vector.y) + ',' + exactly(vector.z) + ')';
}

QByteArray escaped(QByteArray text)
{
    return text.replace('\\', "\\\\").replace('\n', "\\n");
}

QByteArray headerOf(const NrrdImage& image)
{
    const glm::dmat4& affine = image.geometry.indexToWorld;
    const glm::ivec3 size = image.geometry.size;
    QByteArray header("NRRD0004\n"
                      "# Complete NRRD file format specification at:\n"
                      "# http://teem.sourceforge.net/nrrd/format.html\n"
                      "type: unsigned char\n");
    const bool isList = image.layers > 1;
    header += isList ? "dimension: 4\n" : "dimension: 3\n";
    header += "space: left-posterior-superior\nsizes: ";
    if (isList)
        header += QByteArray::number(image.layers) + ' ';
    header += QByteArray::number(size.x) + ' ' + QByteArray::number(size.y) + ' '
        + QByteArray::number(size.z) + '\n';
    header += isList ? "space directions: none" : "space directions:";
    for (int axis = 0; axis < 3; ++axis)
        header += ' ' + inBrackets(glm::dvec3(affine[axis]));
    header += isList ? "\nkinds: list" : "\nkinds:";
    header += " domain domain domain\nencoding: gzip\n";
    header += "space origin: " + inBrackets(glm::dvec3(affine[3])) + '\n';
    for (const auto& [key, value] : image.keyValues)
        header += escaped(key) + ":=" + escaped(value) + '\n';
    return header + '\n';
}

} // namespace

Result<void> writeNrrdAt(const QString& path, const NrrdImage& image)
{
    if (image.layers < 1
        || image.voxels.size() != image.geometry.voxelCount() * std::size_t(image.layers))
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("the voxels are not as many as the grid has"));
    const QByteArray header = headerOf(image);
    PackedOutput words(path, PackedOutput::Form::Plain);
    words.write(header.constData(), std::size_t(header.size()));
    Clause reason = words.close();
    if (reason.isEmpty()) {
        PackedOutput voxels(path, PackedOutput::Form::GzipBehind);
        voxels.write(image.voxels.data(), image.voxels.size());
        reason = voxels.close();
    }
    if (!reason.isEmpty())
        return failure(ErrorCode::FileUnwritable, path, reason);
    return {};
}

} // namespace core
