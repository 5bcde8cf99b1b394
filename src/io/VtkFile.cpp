// Writing and reading of .vtp files in one translation unit: VTK's headers are what costs.

#include "io/VtkFile.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkZLibDataCompressor.h>

#include "core/Errors.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

template <class Array, class T>
vtkSmartPointer<vtkDataArray> filled(T const* values, std::size_t tuples, int components)
{
    using Value = typename Array::ValueType;
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    std::size_t const count = tuples * static_cast<std::size_t>(components);
    std::transform(values, values + count, array->GetPointer(0), [](T value) { return static_cast<Value>(value); });
    return array;
}

vtkSmartPointer<vtkDataArray> realArray(Real const* values, std::size_t tuples, int components, VtkPrecision precision)
{
    if (precision == VtkPrecision::Double) return filled<vtkDoubleArray>(values, tuples, components);
    return filled<vtkFloatArray>(values, tuples, components);
}

vtkSmartPointer<vtkDataArray> vectorArray(std::span<Vector const> values, VtkPrecision precision)
{
    static_assert(sizeof(Vector) == 3 * sizeof(Real));
    return realArray(reinterpret_cast<Real const*>(values.data()), values.size(), 3, precision);
}

vtkSmartPointer<vtkDataArray> integerArray(NamedArrays::IntegerSpan const& span)
{
    return std::visit(
        [](auto values) {
            using T = typename decltype(values)::value_type;
            using Wide = std::conditional_t<std::is_same_v<T, int>, vtkIntArray, vtkTypeInt64Array>;
            using Array = std::conditional_t<std::is_same_v<T, std::uint8_t>, vtkUnsignedCharArray, Wide>;
            return filled<Array>(values.data(), values.size(), 1);
        },
        span);
}

void addArrays(vtkDataSetAttributes& target, NamedArrays const& arrays, std::size_t length, VtkPrecision precision)
{
    auto const add = [&](std::string const& name, std::size_t size, vtkSmartPointer<vtkDataArray> const& array) {
        if (size != length) throw std::logic_error("VTK array \"" + name + "\" has the wrong length");
        array->SetName(name.c_str());
        target.AddArray(array);
    };
    for (auto const& [name, values] : arrays.scalars) add(name, values.size(), realArray(values.data(), values.size(), 1, precision));
    for (auto const& [name, values] : arrays.vectors) add(name, values.size(), vectorArray(values, precision));
    for (auto const& [name, span] : arrays.integers) add(name, std::visit([](auto v) { return v.size(); }, span), integerArray(span));
}

vtkSmartPointer<vtkCellArray> cellArray(std::vector<std::vector<std::int64_t>> const& cells, std::size_t points)
{
    auto array = vtkSmartPointer<vtkCellArray>::New();
    for (auto const& cell : cells)
    {
        array->InsertNextCell(static_cast<int>(cell.size()));
        for (std::int64_t const point : cell)
        {
            expect(point >= 0 && static_cast<std::size_t>(point) < points, "VTK surface: a cell names a point that does not exist");
            array->InsertCellPoint(point);
        }
    }
    return array;
}

void setPoints(vtkPolyData& data, std::span<Vector const> positions, VtkPrecision precision)
{
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(positions, precision));
    data.SetPoints(points);
}

/// Text of the file, written in one go: VTK's own file output does not report a full disk reliably.
void write(std::filesystem::path const& path, vtkPolyData& data, Real time)
{
    auto const timeValue = filled<vtkDoubleArray>(&time, 1, 1);
    timeValue->SetName("TimeValue");
    data.GetFieldData()->AddArray(timeValue);
    vtkNew<vtkZLibDataCompressor> compressor;
    compressor->SetCompressionLevel(1);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(&data);
    writer->SetDataModeToBinary(); // inline base64: some readers refuse appended data
    writer->SetCompressor(compressor);
    writer->WriteToOutputStringOn();
    bool const done = writer->Write() == 1;
    if (!done) throw CaseError(ExitCode::InputOutput, Location{path.string(), 0, {}}, "VTK cannot encode this file");
    atomicWrite(path, writer->GetOutputString(), Durability::Process);
}

} // namespace

void writePointCloud(std::filesystem::path const& path, PointCloud const& cloud, Real time, VtkPrecision precision)
{
    vtkNew<vtkPolyData> data;
    setPoints(*data, cloud.position, precision);
    vtkNew<vtkCellArray> vertices;
    vertices->AllocateExact(static_cast<vtkIdType>(cloud.position.size()), static_cast<vtkIdType>(cloud.position.size()));
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(cloud.position.size()); ++i) vertices->InsertNextCell(1, &i);
    data->SetVerts(vertices);
    addArrays(*data->GetPointData(), cloud, cloud.position.size(), precision);
    write(path, *data, time);
}

void writeSurface(std::filesystem::path const& path, SurfaceCells const& surface, Real time, VtkPrecision precision)
{
    vtkNew<vtkPolyData> data;
    setPoints(*data, surface.points, precision);
    data->SetLines(cellArray(surface.lines, surface.points.size()));
    data->SetPolys(cellArray(surface.polygons, surface.points.size()));
    addArrays(*data->GetCellData(), surface, surface.lines.size() + surface.polygons.size(), precision);
    write(path, *data, time);
}

void writeTriangles(std::filesystem::path const& path, TriangleCells const& surface, Real time, VtkPrecision precision)
{
    std::vector<std::vector<std::int64_t>> cells;
    for (auto const& triangle : surface.triangles) cells.emplace_back(triangle.begin(), triangle.end());
    vtkNew<vtkPolyData> data;
    setPoints(*data, surface.points, precision);
    data->SetPolys(cellArray(cells, surface.points.size()));
    addArrays(*data->GetPointData(), surface, surface.points.size(), precision);
    if (!surface.normals.empty())
    {
        expect(surface.normals.size() == surface.points.size(), "VTK surface: the normals have the wrong length");
        auto const normals = vectorArray(surface.normals, precision);
        normals->SetName("Normals");
        data->GetPointData()->SetNormals(normals);
    }
    write(path, *data, time);
}

namespace {

/// Keeps the first message that VTK has instead of letting it go to the terminal.
void keepMessage(vtkObject*, unsigned long, void* kept, void* message)
{
    auto& text = *static_cast<std::string*>(kept);
    if (text.empty()) text = message ? static_cast<char const*>(message) : "unknown error";
}

std::string lastLine(std::string text)
{
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text.substr(text.find_last_of('\n') + 1);
}

vtkSmartPointer<vtkPolyData> read(std::filesystem::path const& path)
{
    Location const where{path.string(), 0, {}};
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) throw CaseError(ExitCode::InputOutput, where, "cannot read: no such file");
    std::string message;
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(keepMessage);
    observer->SetClientData(&message);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->AddObserver("ErrorEvent", observer);
    reader->GetExecutive()->AddObserver("ErrorEvent", observer);
    reader->SetReaderErrorObserver(observer);
    reader->SetParserErrorObserver(observer);
    reader->SetFileName(path.c_str());
    reader->Update();
    bool const failed = !message.empty() || reader->GetErrorCode() != 0;
    if (failed) throw CaseError(ExitCode::InputOutput, where, "VTK cannot read this file: " + lastLine(message));
    return reader->GetOutput();
}

Real timeOf(vtkPolyData& data)
{
    vtkDataArray* const time = data.GetFieldData()->GetArray("TimeValue");
    return time && time->GetNumberOfTuples() > 0 ? time->GetComponent(0, 0) : 0.0;
}

std::vector<Vector> vectorsOf(vtkDataArray& array)
{
    std::vector<Vector> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i) array.GetTuple(static_cast<vtkIdType>(i), values[i].data());
    return values;
}

std::vector<Vector> pointsOf(vtkPolyData& data)
{
    return data.GetNumberOfPoints() > 0 ? vectorsOf(*data.GetPoints()->GetData()) : std::vector<Vector>();
}

std::vector<Real> scalarsOf(vtkDataArray& array)
{
    std::vector<Real> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = array.GetComponent(static_cast<vtkIdType>(i), 0);
    return values;
}

/// All digits of 64-bit integers, which VTK's way through double would not keep.
std::vector<std::int64_t> integersOf(vtkDataArray& array)
{
    std::vector<std::int64_t> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    bool const wide = array.GetDataTypeSize() == 8;
    if (wide && !values.empty()) std::memcpy(values.data(), array.GetVoidPointer(0), 8 * values.size());
    for (std::size_t i = 0; !wide && i < values.size(); ++i)
        values[i] = static_cast<std::int64_t>(array.GetComponent(static_cast<vtkIdType>(i), 0));
    return values;
}

void takeArrays(vtkDataSetAttributes& from, NamedValues& to)
{
    for (int i = 0; i < from.GetNumberOfArrays(); ++i)
    {
        vtkDataArray* const array = from.GetArray(i);
        if (!array || !array->GetName()) continue;
        std::string const name = array->GetName();
        bool const real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
        if (array->GetNumberOfComponents() == 3)
            to.vectors[name] = vectorsOf(*array);
        else if (array->GetNumberOfComponents() == 1 && real)
            to.scalars[name] = scalarsOf(*array);
        else if (array->GetNumberOfComponents() == 1)
            to.integers[name] = integersOf(*array);
    }
}

std::vector<std::vector<std::int64_t>> cellsOf(vtkCellArray* array)
{
    std::vector<std::vector<std::int64_t>> cells;
    vtkNew<vtkIdList> points;
    for (vtkIdType i = 0; array && i < array->GetNumberOfCells(); ++i)
    {
        array->GetCellAtId(i, points);
        cells.emplace_back(points->begin(), points->end());
    }
    return cells;
}

} // namespace

PointCloudData readPointCloud(std::filesystem::path const& path)
{
    auto const data = read(path);
    PointCloudData cloud;
    cloud.time = timeOf(*data);
    cloud.position = pointsOf(*data);
    takeArrays(*data->GetPointData(), cloud);
    return cloud;
}

SurfaceData readSurface(std::filesystem::path const& path)
{
    auto const data = read(path);
    SurfaceData surface;
    surface.time = timeOf(*data);
    surface.points = pointsOf(*data);
    surface.lines = cellsOf(data->GetLines());
    surface.polygons = cellsOf(data->GetPolys());
    takeArrays(*data->GetCellData(), surface);
    return surface;
}

} // namespace mpsDem
