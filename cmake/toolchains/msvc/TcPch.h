// The parts of TwinCAT's headers that the example of a TcCOM module in docs/runtime.md uses, just enough to
// compile it.
#pragma once

#include <stddef.h>
#include <stdint.h>

typedef long HRESULT;
typedef unsigned long ULONG;
typedef unsigned __int64 ULONG_PTR;
#define S_OK ((HRESULT)0L)
#define E_FAIL ((HRESULT)0x80004005L)
#define FAILED(hr) ((HRESULT)(hr) < 0)
#define SUCCEEDED(hr) ((HRESULT)(hr) >= 0)
#define IMPLEMENT_ITCOMOBJECT_EVALUATE_INITDATA(P) \
  if (SUCCEEDED(hr) && P) hr = S_OK

struct TComInitDataHdr;
typedef TComInitDataHdr* PTComInitDataHdr;
struct ITcUnknown {};
struct ITcTask : ITcUnknown {
  virtual HRESULT GetCycleTime(ULONG* nanoseconds) = 0;
};

inline constexpr uint32_t axes = 4;

// The part that TwinCAT's wizard generates.
class CFilterModule {
 public:
  HRESULT SetObjStatePS(PTComInitDataHdr pInitData);
  HRESULT SetObjStateSO();
  HRESULT SetObjStateSP();
  HRESULT CycleUpdate(ITcTask* ipTask, ITcUnknown* ipCaller, ULONG_PTR context);
  HRESULT AddModuleToCaller();

 private:
  struct {
    ULONG CycleTimeNs;
    ULONG ImageSize;
    unsigned char Image[65536];
  } m_Parameter;
  struct {
    double Setpoint[axes];
    double Position[axes];
    bool Enable[axes];
  } m_Inputs;
  struct {
    double Filtered[axes];
    ULONG Status;
  } m_Outputs;
  char* m_pBlocks = nullptr;
  struct axisrt* m_pRuntime = nullptr;
  bool m_WasEnabled[axes] = {};
  bool m_Checked = false;
};
