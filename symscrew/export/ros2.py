"""ros2_control of a model: a C++17 class without ROS, and a package with the mechanism as a transmission.

<name>_kinematics.hpp        drives <-> tool, rates, efforts, margins; needs <name>_drives_host.c, nothing of ROS
<name>_transmission.hpp      transmission_interface::Transmission around it
<name>_kinematics_plugin.hpp    kinematics_interface::KinematicsInterface around it
<name>_transmission.cpp, <name>_kinematics_plugin.cpp, package.xml, CMakeLists.txt,
transmission_plugins.xml, kinematics_plugins.xml     the plugins that load them
"""

from __future__ import annotations

from symscrew.description import namespace
from symscrew.export.drive_kinematics import DriveKinematics
from symscrew.export.drive_kinematics_c import axes_text, print_drive_host, template
from symscrew.export.listing import banner, check_names, decimal, plain, wrapped
from symscrew.model import Model

LOADER = """\
#include <memory>

#include "@FILE@_transmission.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "transmission_interface/transmission_loader.hpp"

namespace @SPACE@ {

class TransmissionLoader : public transmission_interface::TransmissionLoader {
public:
    std::shared_ptr<transmission_interface::Transmission> load(const hardware_interface::TransmissionInfo &) override
    {
        return std::make_shared<Transmission>();
    }
};

} /* namespace @SPACE@ */

PLUGINLIB_EXPORT_CLASS(@SPACE@::TransmissionLoader, transmission_interface::TransmissionLoader)
"""
PLUGIN = """\
#include "@FILE@_kinematics_plugin.hpp"
#include "pluginlib/class_list_macros.hpp"

PLUGINLIB_EXPORT_CLASS(@SPACE@::KinematicsPlugin, kinematics_interface::KinematicsInterface)
"""
PACKAGE = """\
<?xml version="1.0"?>
<package format="3">
  <name>@PACKAGE@</name>
  <version>0.0.0</version>
  <description>@MODEL@ as a transmission and as kinematics of ros2_control</description>
  <maintainer email="nobody@example.org">nobody</maintainer>
  <license>to be named</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <depend>eigen</depend>
  <depend>hardware_interface</depend>
  <depend>kinematics_interface</depend>
  <depend>pluginlib</depend>
  <depend>transmission_interface</depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(@PACKAGE@ LANGUAGES C CXX)

find_package(ament_cmake REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(hardware_interface REQUIRED)
find_package(kinematics_interface REQUIRED)
find_package(pluginlib REQUIRED)
find_package(transmission_interface REQUIRED)

add_library(@PACKAGE@ SHARED
  @FILE@_transmission.cpp @FILE@_kinematics_plugin.cpp @FILE@_drives_host.c)
set_target_properties(@PACKAGE@ PROPERTIES C_STANDARD 99 CXX_STANDARD 17)
target_include_directories(@PACKAGE@ PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
ament_target_dependencies(@PACKAGE@ hardware_interface kinematics_interface pluginlib transmission_interface)
target_link_libraries(@PACKAGE@ Eigen3::Eigen)
pluginlib_export_plugin_description_file(transmission_interface transmission_plugins.xml)
pluginlib_export_plugin_description_file(kinematics_interface kinematics_plugins.xml)
install(TARGETS @PACKAGE@ LIBRARY DESTINATION lib)
ament_package()
"""
PLUGINS = """\
<library path="@PACKAGE@">
  <class name="@PACKAGE@/Transmission" type="@SPACE@::TransmissionLoader"
         base_class_type="transmission_interface::TransmissionLoader">
    <description>Drives of @MODEL@ and the axes of its tool</description>
  </class>
</library>
"""
KINEMATICS_PLUGINS = """\
<library path="@PACKAGE@">
  <class name="@PACKAGE@/KinematicsPlugin" type="@SPACE@::KinematicsPlugin"
         base_class_type="kinematics_interface::KinematicsInterface">
    <description>From drives of @MODEL@ to its tool and back</description>
  </class>
</library>
"""


def print_ros2(model: Model, kinematics: DriveKinematics) -> dict[str, str]:
    """File name to text."""
    check_names(model)
    name = model.name
    package = f"{name.lower().strip('_')}_ros2"
    numbers = {
        "COORDINATES": len(kinematics.model.system.tree.q),
        "FREEDOMS": len(kinematics.axes),
        "DRIVES": len(kinematics.drives),
    }
    words = {
        **{word: str(value) for word, value in numbers.items()},
        "AXES": ", ".join(map(str, kinematics.axes)),
        "CHOSEN": ", ".join(map(str, kinematics.chosen)),
        "GUARD": name.upper(), "FOLLOW": kinematics.model.name, "SPACE": namespace(name), "PACKAGE": package,
        "FILE": name, "MODEL": name, "PLATFORM": str(model.mechanism.platform),
        "PER_LENGTH": decimal(1 / float(kinematics.model.system.length)),
    }  # fmt: skip
    about = [*banner(model)[:3], *wrapped(plain(axes_text(kinematics)), later="  ")]
    head = "\n".join(["/*", *(f" * {line}".rstrip() for line in about), " */", ""])
    texts = {
        f"{name}_kinematics.hpp": head + template("ros2_kinematics.hpp"),
        f"{name}_transmission.hpp": head + template("ros2_transmission.hpp"),
        f"{name}_transmission.cpp": head + LOADER,
        f"{name}_kinematics_plugin.hpp": head + template("ros2_plugin.hpp"),
        f"{name}_kinematics_plugin.cpp": head + PLUGIN,
        "package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "transmission_plugins.xml": PLUGINS,
        "kinematics_plugins.xml": KINEMATICS_PLUGINS,
    }  # fmt: skip
    for word, meaning in words.items():
        texts = {file: text.replace(f"@{word}@", meaning) for file, text in texts.items()}
    return {**texts, **print_drive_host(kinematics)}
