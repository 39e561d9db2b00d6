/* For tests without LinuxCNC. */
#define EXPORT_SYMBOL(name) extern int stub_exported
#define MODULE_LICENSE(text) extern int stub_licensed
int rtapi_app_main(void);
void rtapi_app_exit(void);
