// For tests without ROS: makes one, in place of a registered plugin.
#include <memory>
#define PLUGINLIB_EXPORT_CLASS(derived, base) \
    std::unique_ptr<base> make_plugin(); \
    std::unique_ptr<base> make_plugin() { return std::make_unique<derived>(); }
